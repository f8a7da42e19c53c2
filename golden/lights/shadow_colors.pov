// Shadows through filter, transmit, patterned and layered glass, with ior and without, and double shadows.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4.5, -7> look_at <0, 0.2, 0.3> angle 44 }
plane { y, 0 pigment { rgb 0.85 } }
sphere { <-1.2, 0.5, 0.4>, 0.5 pigment { rgb <0.9, 0.8, 0.7> } finish { phong 0.5 } }
cylinder { <0.1, 0, 0.2>, <0.1, 1, 0.2>, 0.25 pigment { rgb <0.8, 0.5, 0.3> } }
box { <1.1, 0, 0>, <1.8, 0.8, 0.8> pigment { rgb <0.5, 0.6, 0.8> } }

light_source { <-3, 6, -2> rgb 1 }
light_source { <4, 6, -1> rgb <0.4, 0.4, 0.5> }
disc { <-1.4, 2.2, -0.6>, y, 0.7 pigment { checker rgbf <1, 0.5, 0.2, 0.9> rgbt <0, 0, 0, 0.4> scale 0.3 translate 0.02 } }
disc { <0.4, 2.2, -0.3>, y, 0.6 texture { pigment { rgbf <0.3, 1, 0.3, 0.9> } } texture { pigment { rgbf <1, 1, 0.2, 0.8> } } }
sphere { <1.9, 1.6, 0>, 0.5 pigment { rgbf <0.7, 0.8, 1, 0.9> } interior { ior 1.4 } }
