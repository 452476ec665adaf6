from .painting import Painter as Painter
from .painting import painter as painter
from .settings import Camera as Camera
from .settings import RenderSettings as RenderSettings
from .still_pictures import figures as figures
from .styles import STYLES as STYLES
