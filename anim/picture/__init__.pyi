from .look import STYLES as STYLES
from .look import Camera as Camera
from .look import Look as Look
from .painting import Painter as Painter
from .painting import painter as painter
from .thesis import figures as figures
