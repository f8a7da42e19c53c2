// A glass ball gathers light on a floor.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.03 } }
camera { location <0, 4, -6> look_at <0.4, 0.3, 0> right 4/3*x up y angle 40 }
light_source { <-4, 7, -1>, rgb 1 photons { refraction on reflection on } }
plane { y, 0 pigment { rgb <0.8, 0.75, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
sphere { <0, 1, 0>, 0.8 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.02 specular 0.3 } interior { ior 1.5 }
  photons { target refraction on reflection off collect off } }
