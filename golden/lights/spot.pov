// spotlight: radius, falloff and tightness; falloff below radius; a wide one.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4.5, -7> look_at <0, 0.2, 0.3> angle 44 }
plane { y, 0 pigment { rgb 0.85 } }
sphere { <-1.2, 0.5, 0.4>, 0.5 pigment { rgb <0.9, 0.8, 0.7> } finish { phong 0.5 } }
cylinder { <0.1, 0, 0.2>, <0.1, 1, 0.2>, 0.25 pigment { rgb <0.8, 0.5, 0.3> } }
box { <1.1, 0, 0>, <1.8, 0.8, 0.8> pigment { rgb <0.5, 0.6, 0.8> } }

light_source { <-2.4, 3, 0> rgb <1, 0.7, 0.5> spotlight point_at <-2.4, 0, 0.2> radius 12 falloff 20 tightness 0 }
light_source { <0, 3, 0> rgb <0.5, 1, 0.5> spotlight point_at <0, 0, 0.2> radius 18 falloff 25 tightness 15 }
light_source { <2.4, 3, 0> rgb <0.5, 0.7, 1> spotlight point_at <2.4, 0, 0.2> radius 18 falloff 10 tightness 2 }
light_source { <0, 6, -6> rgb 0.4 spotlight point_at <0, 0, 2> }
