from .look import Camera as Camera
from .look import Look as Look
from .painting import Painter as Painter
from .painting import painter as painter
from .still_pictures import figures as figures
from .styles import STYLES as STYLES
