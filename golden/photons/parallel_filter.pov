// Parallel light through coloured panes, one above the other; no version is said.
global_settings { photons { spacing 0.05 gather 20, 60 } }
camera { location <0, 4, -6> look_at <0, 0.5, 0> right 4/3*x up y angle 38 }
light_source { <1, 8, 0>, rgb 1 parallel point_at <0, 0, 0> photons { refraction on } }
plane { y, 0 pigment { rgb 1 } finish { ambient 0.05 diffuse 0.7 } }
box { <-1.5, 1.5, -1>, <0.5, 1.6, 1> pigment { rgbf <1, 0.4, 0.3, 0.9> } finish { ambient 0 diffuse 0.1 }
  photons { target refraction on reflection off } }
box { <-0.5, 0.9, -0.8>, <1.5, 1, 0.8> pigment { rgbf <0.3, 0.5, 1, 0.9> } finish { ambient 0 diffuse 0.1 }
  photons { target refraction on reflection off } }
