// crand: grain on the diffuse light, averaged over many lights so that chance stays small.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0, -8> look_at 0 angle 40 }
background { rgb <0.4, 0.5, 0.7> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb 0.2 translate 0.1 } }
// Each light draws a number of its own: the mean darkens by half of crand, and the grain by the root of 400.
#declare Lights = 20;
#for (I, 1, Lights)
  #for (J, 1, Lights)
    light_source { <-5 + I / 20, 6 + J / 20, -8> rgb <1, 0.95, 0.9> / (Lights * Lights) }
  #end
#end
#declare Ball = sphere { 0, 0.9 pigment { rgb <0.7, 0.4, 0.3> } }
object { Ball finish { crand 0.1 } translate <-2, 0.4, 0> }
object { Ball finish { crand 0.12 diffuse 0.8 } translate <0, 0.4, 0> }
object { Ball finish { crand 0.1 diffuse 0.7 brilliance 2 } translate <2, 0.4, 0> }
