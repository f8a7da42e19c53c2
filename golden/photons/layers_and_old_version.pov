// Layers of a pane, and what `target` alone does, in an old scene.
#version 3.5;
global_settings { photons { spacing 0.06 radius 0.2 } }
camera { location <0, 4, -6> look_at <0, 0.5, 0> right 4/3*x up y angle 38 }
light_source { <2, 6, -2>, rgb 1 photons { refraction on reflection off } }
plane { y, 0 pigment { rgb <1, 0.9, 0.8> } finish { ambient 0.1 diffuse 0.7 brilliance 2 } }
box { <-1.5, 1, -1>, <0, 1.1, 1>
  texture { pigment { rgbf <1, 0.6, 0.4, 0.8> } finish { ambient 0 diffuse 0.2 } }
  texture { pigment { checker rgbf <0.5, 0.8, 1, 0.9> rgbt <1, 1, 1, 1> scale 0.5 } finish { ambient 0 diffuse 0.2 } }
  photons { target } }
sphere { <0.9, 0.7, 0>, 0.5 pigment { rgb 0.9 } finish { ambient 0 diffuse 0.2 reflection 0.6 } photons { target reflection on } }
