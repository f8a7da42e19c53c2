// Light behind a lens shows in the air of a box.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.04 media 60 } }
camera { location <0, 2, -7> look_at <0, 1.2, 0> right 4/3*x up y angle 40 }
light_source { <0, 8, 0>, rgb 1 parallel point_at 0 photons { refraction on reflection off } }
plane { y, 0 pigment { rgb 0.6 } finish { ambient 0 diffuse 0.7 } }
sphere { 0, 1 scale <0.8, 0.4, 0.8> translate 2.6*y hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.4 }
  photons { target refraction on reflection off collect off } }
box { <-1.6, 0.1, -1.2>, <1.6, 2.1, 1.2> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
  interior { media { scattering { 1, 0.15 extinction 0.5 } method 3 } } photons { refraction on collect off pass_through } }
