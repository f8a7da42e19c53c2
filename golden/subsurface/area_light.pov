// An area light, whose grid shines into the material in full.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 100, 20 } }
camera { location <0, 2.5, -5> look_at <0, 0.3, 0> right 4/3*x up y angle 45 }
light_source { <-3, 5, -3>, rgb 0.8 area_light 2*x, 2*z, 4, 4 adaptive 1 }
plane { y, -0.5 pigment { rgb 0.6 } finish { ambient 0.05 diffuse 0.7 } }
superellipsoid { <0.4, 0.4> scale 0.8 rotate 25*y
  pigment { rgb <0.9, 0.85, 0.7> } interior { ior 1.5 }
  finish { ambient 0 diffuse 0.8 subsurface { translucency 0.8 } }
}
box { <0.2, 0.9, -1>, <1.2, 1.1, -0.8> pigment { rgb <0.2, 0.3, 0.6> } }
