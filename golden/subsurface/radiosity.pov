// Light of the sky goes below the surface, too.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 60 } subsurface { samples 60, 20 radiosity on } }
camera { location <0, 2, -5> look_at <0, 0.5, 0> right 4/3*x up y angle 45 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.7, 0.6, 0.5>] [1 rgb <0.3, 0.5, 0.9>] } } }
light_source { <4, 6, -4>, rgb 0.5 }
plane { y, 0 pigment { rgb 0.6 } finish { diffuse 0.7 } }
sphere { <-0.8, 0.8, 0>, 0.8 pigment { rgb <0.9, 0.8, 0.7> } finish { diffuse 0.8 subsurface { translucency 0.8 } } interior { ior 1.4 } }
box { <0.3, 0, -0.5>, <1.4, 1, 0.6> pigment { rgb <0.7, 0.8, 0.9> } finish { diffuse 0.8 subsurface { translucency 0.4 } } interior { ior 1.4 } rotate 20*y }
