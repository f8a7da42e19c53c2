//! about: 10^X differences, one in the other
//! extremity: 10^X
//! steps: 1 2 3 3.5 4
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare O = sphere { 0, 2 }
#declare I = 0;
#while (I < pow(10, X)) #declare O = difference { object { O } sphere { <0, 50 + I, 0>, 1 } } #declare I = I + 1; #end
object { O pigment { rgb 1 } }
