#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
light_source { <5, 5, -5>, rgb 1 }
#for (i = 0; i < 5; i++) sphere { i*x, 1 } #end
