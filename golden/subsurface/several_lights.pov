// Four kinds of lights on a row of balls.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 150, 30 } }
camera { location <0, 3, -7> look_at <0, 0.4, 0> right 4/3*x up y angle 40 }
light_source { <-6, 5, -3>, rgb <0.5, 0.1, 0.1> parallel point_at 0 }
light_source { <6, 5, -3>, rgb <0.1, 0.1, 0.6> fade_distance 6 fade_power 2 }
light_source { <0, 6, -1>, rgb <0.2, 0.7, 0.2> spotlight point_at 0 radius 8 falloff 14 tightness 2 }
light_source { <0, 1, -8>, rgb 0.1 shadowless }
plane { y, -0.6 pigment { rgb 0.6 } }
#declare K = -2;
#while (K < 3)
  sphere { <1.2*K, 0, 0>, 0.55
    pigment { rgb <0.9, 0.8, 0.7> } interior { ior 1.3 }
    finish { ambient 0.02 diffuse 0.7 subsurface { translucency 0.3*(K + 3) } }
  }
  #declare K = K + 1;
#end
