// An older version with a gamma of its own.
#version 3.5;
global_settings { assumed_gamma 2.2 subsurface { samples 150, 40 } }
camera { location <0, 1, -5> look_at 0 right 4/3*x up y angle 40 }
light_source { <-5, 6, -4>, rgb 0.8 }
sphere { <-0.9, 0, 0>, 0.8 pigment { rgb <0.8, 0.7, 0.6> } finish { diffuse 0.8 subsurface { translucency 1.5 } } interior { ior 1.3 } }
box { <0.1, -0.8, -0.7>, <1.6, 0.6, 0.7> pigment { rgbf <0.6, 0.7, 0.8, 0.3> } finish { diffuse 0.8 subsurface { translucency 0.7 } } interior { ior 1.3 } rotate 10*y }
