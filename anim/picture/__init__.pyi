from .look import Camera as Camera
from .look import Look as Look
from .painting import Painter as Painter
from .painting import painter as painter
from .styles import STYLES as STYLES
from .thesis import figures as figures
