// Only the first mistake of each sort is told, not what follows from it.
#version 3.7;
#include "colors.inc"
#declare Size = 2 * Lenght;
#declare Ring = torus { Size, 0.1 }
#macro Post(X)
  box { <X, 0, 0>, <X + Size, 1, 1> pigment { Wite } }
#end
object { Ring }
union { Post(1) Post(2) object { Ring } }
#while (Size > 0)
  sphere { 0, Size }
  #declare Size = Size - 1;
#end
sphere { 0, 1 pigment { Red } finish { fong 1 } }
