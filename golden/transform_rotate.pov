// rotate: about each axis, about all three at once, and the same three turns one after the other.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -9> look_at 0 angle 42 }
light_source { <-6, 9, -8> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Brick = box { <-0.8, -0.45, -0.3>, <0.8, 0.45, 0.3> pigment { checker rgb 1 rgb <0.8, 0.3, 0.2> scale 0.4 } }

object { Brick rotate 50 * x translate <-2.4, 1.4, 0> }
object { Brick rotate 50 * y translate <0, 1.4, 0> }
object { Brick rotate 50 * z translate <2.4, 1.4, 0> }
object { Brick rotate <35, 50, -25> translate <-1.3, -1.3, 0> }
object { Brick rotate -25 * z rotate 50 * y rotate 35 * x translate <1.3, -1.3, 0> }
