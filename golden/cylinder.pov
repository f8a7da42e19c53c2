// cylinder: closed, open, thin and slanted.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -7> look_at <0, -0.1, 0> angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

cylinder { <-1.7, -1, 0>, <-1.7, 1, 0>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } }
cylinder { <0, -0.7, 0>, <0.2, 0.8, -0.3>, 0.6 open pigment { rgb <0.3, 0.7, 0.3> } }
cylinder { <0.9, -1, 1>, <2.3, 1.1, -0.6>, 0.25 pigment { rgb <0.3, 0.4, 0.9> } finish { phong 0.8 } }
