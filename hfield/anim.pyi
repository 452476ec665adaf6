from anim import *
