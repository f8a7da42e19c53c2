// Radiosity beside light below surfaces: on the surface, and in what it lights, which sees it.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 60 subsurface on } subsurface { samples 30, 10 } }
camera { location <0, 2, -5> look_at <0, 0.5, 0> right 4/3*x up y angle 45 }
background { rgb <0.3, 0.35, 0.4> }
light_source { <4, 6, -4>, rgb 0.7 }
plane { y, 0 pigment { rgb 0.6 } finish { diffuse 0.7 } }
sphere { <-0.8, 0.8, 0>, 0.8 pigment { rgb <0.9, 0.5, 0.4> } finish { diffuse 0.8 subsurface { translucency 0.8 } } interior { ior 1.4 } }
sphere { <0.9, 0.6, 0>, 0.6 pigment { rgb <0.5, 0.6, 0.9> } finish { diffuse 0.8 } }
