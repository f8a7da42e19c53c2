#include "functions.inc"
#declare F = function { x * y - sin(z) ^ 2 }
#declare G = function(a, b) { F(a, b, 1) + pow(a, 2) * (a > b) - sum(i, 1, 3, i * a) }
#declare P = function { pigment { bozo turbulence 0.3 color_map { [0 rgb 0] [1 rgb 1] } } }
#declare S = function { spline { cubic_spline -1, 0 * x, 0, x, 1, y, 2, z } }
#declare T = function { transform { rotate 30 * y inverse } }
#declare N = function { f_noise3d(x, y, z) + f_sphere(x, y, z, 1) }
#declare K = spline { linear_spline 0, <1, 2>, 1, <3, 4> }
#debug vstr(3, P(0.1, 0.2, 0.3), ",", 0, 4)
#debug vstr(3, T(1, 2, 3), ",", 0, 4)
#debug str(G(1, 2) + S(0.5).x + K(0.25).y, 0, 3)
isosurface { function { N(x, y, z) - 0.3 } contained_by { box { -1, 1 } } max_gradient 3 }
plane { y, 0 pigment { function { abs(F(x, y, z)) } } }
