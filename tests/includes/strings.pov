// Strings of numbers, vectors, colours and triangles.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "strings.inc"
#macro Show(S) #debug concat("@[", S, "]\n") #end
Show(Str(1 / 3))
Show(Str(-12345))
Show(VStr2D(<1 / 3, 2>))
Show(VStr(<1, 2 / 3, -3>))
Show(Vstr2D(<1 / 3, 2>, 6, 2))
Show(Vstr(<1 / 3, 2, -3>, -8, 1))
Show(CRGBStr(rgb <1, 0.5, 1 / 3>, 0, 3))
Show(CRGBStr(rgb <1, 0.5, 1 / 3>, 7, 1))
Show(CRGBFTStr(rgbft <1, 0.5, 1 / 3, 0.2, 0.1>, -8, 2))
#declare T = Triangle_Str(<0, 0, 0>, <1, 0, 1 / 3>, <0, 1, 0>)
Show(substr(T, 1, 40))
Show(substr(T, 41, strlen(T) - 40))
#declare T = Smooth_Triangle_Str(<0, 0, 0>, y, <1, 0, 0>, y, <0, 1, 0>, z)
Show(substr(T, 1, 60))
Show(substr(T, 61, 60))
Show(substr(T, 121, strlen(T) - 120))
