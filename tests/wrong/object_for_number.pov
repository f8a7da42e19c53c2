// An object's name where a number is needed.
#declare Ball = sphere { 0, 1 }
box { -1, Ball }
