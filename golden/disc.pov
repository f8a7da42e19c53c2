// disc: whole and with a hole, from both sides.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2, -7> look_at 0 angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

disc { <-1.4, 0, 0>, <0.3, 1, -0.6>, 1.2 pigment { rgb <0.8, 0.3, 0.2> } }
disc { <1.2, 0.3, 0>, <-0.3, 0.5, -1>, 1.2, 0.5 pigment { checker rgb 1 rgb <0.3, 0.7, 0.3> scale 0.4 } }
disc { <0.3, -1.1, -0.5>, <0, -1, 0.1>, 0.8, 0.2 pigment { rgb <0.3, 0.4, 0.9> } }
