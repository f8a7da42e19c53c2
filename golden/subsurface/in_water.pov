// Under water: a material in something that bends light itself, and one that light comes through to its far side.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 200, 40 } }
camera { location <0, 1, -5> look_at 0 right 4/3*x up y angle 40 }
light_source { <-5, 6, -4>, rgb 0.5 }
sphere { 0, 20 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.33 } }
sphere { <-0.9, 0, 0>, 0.8 pigment { rgb <0.8, 0.5, 0.3> } finish { ambient 0 diffuse 0.8 subsurface { translucency 1 } } interior { ior 2 } }
box { <0.3, -0.7, -0.6>, <1.5, 0.6, 0.6> pigment { rgbf <0.6, 0.7, 0.8, 0.3> } finish { ambient 0 diffuse 0.7 subsurface { translucency 0.7 } } interior { ior 1.6 } rotate 10*y }
