// spot light: the soft edge between radius and falloff, and a hard one with tightness 0.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4, -5> look_at <0, 0, 0.5> angle 50 }
light_source { <-1.8, 4, -1> rgb <1, 0.8, 0.6> spotlight point_at <-1.5, 0, 0.5> radius 8 falloff 22 tightness 4 }
light_source { <2, 3, -2> rgb <0.5, 0.7, 1> spotlight point_at <1.4, 0, 0.5> radius 18 falloff 18.5 tightness 0 }
plane { y, 0 pigment { rgb 0.8 } }
sphere { <0, 0.5, 0.5>, 0.5 pigment { rgb 0.7 } }
