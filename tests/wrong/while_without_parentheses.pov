#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
light_source { <5, 5, -5>, rgb 1 }
#declare i = 0;
#while i < 5
  sphere { <i, 0, 0>, 0.5 pigment { rgb 1 } }
  #declare i = i + 1;
#end
