// ovus: bottom larger, top larger, and cut open.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

ovus { 1, 0.5 scale 0.8 translate <-1.9, -0.4, 0> pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.5 } }
ovus { 0.6, 1 scale 0.8 rotate 20 * z translate <0.3, -0.6, 0> pigment { rgb <0.3, 0.7, 0.3> } }
difference { ovus { 0.8, 0.4 } plane { <0, -1, 0.6>, -0.2 pigment { rgb <0.9, 0.8, 0.3> } } translate <1.9, -0.2, 0> pigment { rgb <0.3, 0.4, 0.9> } }
