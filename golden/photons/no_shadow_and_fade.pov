// Coloured glass that swallows light on its way; an object that photons do not see.
#version 3.7;
global_settings { assumed_gamma srgb photons { spacing 0.03 } }
camera { location <0, 3, -5> look_at <0.2, 0.5, 0> right 4/3*x up y angle 45 }
light_source { <-4, 6, -1>, srgb <1, 0.95, 0.9> }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }
box { <-1.6, 1.6, -0.6>, <-0.8, 1.7, 0.6> pigment { rgb <0.9, 0.2, 0.2> } no_shadow }
superellipsoid { <0.4, 0.4> scale 0.7 translate 0.9*y pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
  interior { ior 1.33 fade_distance 0.8 fade_power 1001 fade_color rgb <0.2, 0.7, 0.9> }
  photons { target refraction on reflection off collect off } }
