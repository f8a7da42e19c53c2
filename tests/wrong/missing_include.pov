// An include file that does not exist.
#include "my_colours.inc"
sphere { 0, 1 }
