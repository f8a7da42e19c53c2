// matrix: a shear, a turn written out by hand, and a matrix that mirrors and moves.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -9> look_at 0 angle 42 }
light_source { <-6, 9, -8> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Brick = box { -0.7, 0.7 pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.9, 0.9, 0.3>] } scale 1.5 translate -0.74 * x } }

object { Brick matrix <1, 0, 0, 0.6, 1, 0, 0, 0, 1, -2.3, 1.2, 0> }
object { Brick matrix <0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1, 0.6, 1.2, 0> }
object { Brick matrix <-0.9, 0.1, 0.3, 0.2, 0.7, 0.5, 0.1, -0.4, 1, -1.2, -1.3, 0> }
object { Brick matrix <1, 0.2, 0, 0, 0.6, 0, 0.7, 0.3, 1, 1.8, -1.2, 0> }
