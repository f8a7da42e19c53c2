//! about: 10^X differences, one in the other, each of which takes something away
//! extremity: 10^X
//! steps: 1 2 3 3.5
//! truth: time n^1 memory n^1
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare O = sphere { 0, 3 }
#declare I = 0;
// Places all over the sphere, by the golden angle.
#while (I < pow(10, X))
  #declare H = 1 - 2 * mod(I * .618034, 1);
  #declare O = difference { object { O } sphere { 3 * <sqrt(1 - H * H) * cos(2.4 * I), H, sqrt(1 - H * H) * sin(2.4 * I)>, 6 / sqrt(pow(10, X)) } }
  #declare I = I + 1;
#end
object { O pigment { rgb 1 } }
