from .format import Film as Film
from .formats import FORMATS as FORMATS
from .sheet import sheet as sheet
from .writing import check as check
from .writing import open_film as open_film
