// sphere: near, far, touching and overlapping.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0.6, -7> look_at 0 angle 40 }
light_source { <-5, 7, -9> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

sphere { <-1.2, 0, 0>, 1 pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.5 } }
sphere { <0.5, 0.4, 1>, 1.1 pigment { rgb <0.3, 0.7, 0.3> } }
sphere { <1.2, -0.5, -1>, 0.5 pigment { rgb <0.3, 0.4, 0.9> } }
sphere { <0.2, -0.7, -1>, 0.5 pigment { rgb <0.9, 0.8, 0.3> } }
sphere { 0, 30 pigment { rgb <0.2, 0.2, 0.3> } inverse }
