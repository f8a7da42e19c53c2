//! about: 10^X panes of glass one behind the other
//! extremity: 10^X
//! steps: 1 1.5 2 2.3
//! truth: time n^1 memory n^0
#version 3.7;
global_settings { assumed_gamma 1 }
global_settings { max_trace_level 255 adc_bailout 0 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare I = 0;
#while (I < pow(10, X)) box { <-4, -3, I>, <4, 3, I + .5> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } } #declare I = I + 1; #end
plane { z, 300 pigment { checker rgb 1 rgb 0 scale 20 } finish { ambient 1 } }
