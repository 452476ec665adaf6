from rotation import *
