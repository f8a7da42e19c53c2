// scale: flattened, stretched and shrunk; the patterns and highlights go with the object.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -9> look_at 0 angle 42 }
light_source { <-6, 9, -8> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Ball = sphere { 0, 1 pigment { checker rgb 1 rgb <0.2, 0.4, 0.8> scale 0.5 } finish { phong 0.6 } }

object { Ball scale <1.3, 0.4, 1> translate <-1.8, 1.3, 0> }
object { Ball scale <0.3, 1.1, 0.3> translate <0.5, 1.1, 0> }
object { Ball scale 0.5 translate <2.2, 1.2, 0> }
object { Ball scale <2.4, 0.5, 0.2> rotate 20 * z translate <0, -1.4, 0> }
