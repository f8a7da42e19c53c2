// A mirror and glass show light between surfaces, and sample rays meet them.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 80 } }
camera { location <0, 1.5, -4.5> look_at <0, 1.2, 0> right 4/3*x up y angle 65 }

#declare Wall = finish { diffuse 0.8 }
light_source { <0.5, 2.6, -1>, rgb 0.7 fade_distance 2 fade_power 2 }
box { <-2, 0, -5>, <2, 3, 2> hollow pigment { rgb 0.9 } finish { Wall } }
box { <-2, 0, -5>, <-1.98, 3, 2> pigment { rgb <0.9, 0.3, 0.2> } finish { Wall } }
box { <1.98, 0, -5>, <2, 3, 2> pigment { rgb <0.2, 0.4, 0.9> } finish { Wall } }

sphere { <-0.8, 0.8, 0>, 0.8 pigment { rgb 0.1 } finish { diffuse 0.1 reflection 0.8 } }
sphere { <0.9, 0.7, -0.8>, 0.7 pigment { rgbf <1, 1, 1, 0.9> } finish { diffuse 0.1 reflection 0.1 } interior { ior 1.3 } }
