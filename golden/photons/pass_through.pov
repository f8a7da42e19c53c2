// A pane that photons pass by on their way to a lens.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.03 jitter 0.2 } }
camera { location <0, 4, -6> look_at <0.4, 0.3, 0> right 4/3*x up y angle 40 }
light_source { <-4, 7, -1>, rgb 1 spotlight radius 15 falloff 20 point_at <0, 1, 0> }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }
box { <-4, 3, -2>, <0, 3.05, 2> pigment { rgbf <0.6, 1, 0.6, 0.9> } finish { ambient 0 diffuse 0 } photons { pass_through } }
sphere { 0, 1 scale <0.9, 0.5, 0.9> translate 1.2*y pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.4 }
  photons { target refraction on reflection off collect off } }
