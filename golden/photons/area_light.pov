// Each sample of an area light shoots.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.05 } }
camera { location <0, 4, -6> look_at <0.4, 0.3, 0> right 4/3*x up y angle 40 }
light_source { <-3, 6, -1>, rgb 1 area_light 1.5*x, 1.5*z, 3, 3 photons { area_light refraction on reflection on } }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 phong 0.2 } }
sphere { <0, 1, 0>, 0.7 pigment { rgbf <1, 0.8, 0.9, 0.95> } finish { ambient 0 diffuse 0 } interior { ior 1.4 }
  photons { target 0.8 refraction on } }
