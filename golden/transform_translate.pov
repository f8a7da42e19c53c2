// translate: three copies of a box moved along each axis, and one moved along all three.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <1, 4, -9> look_at <1, 0.8, 0> angle 38 }
light_source { <-6, 9, -8> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Brick = box { -0.4, 0.4 pigment { rgb <0.8, 0.5, 0.2> } }

object { Brick }
object { Brick translate 2 * x pigment { rgb <0.8, 0.2, 0.2> } }
object { Brick translate 1.6 * y pigment { rgb <0.3, 0.8, 0.2> } }
object { Brick translate 3 * z pigment { rgb <0.2, 0.4, 0.9> } }
object { Brick translate <3.2, 1.8, 1> }
