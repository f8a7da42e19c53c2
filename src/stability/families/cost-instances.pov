//! about: 10^X copies by nesting, ten in each union
//! extremity: 10^X
//! steps: 2 4 6 8 9 12 15
//! truth: time n^0 memory n^0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 60 }
light_source { <6, 9, -7>, 1 }
#declare O = sphere { 0, .3 }
#declare I = 0;
#while (I < X)
  #declare O = union { #declare K = 0; #while (K < 10) object { O scale .4 translate x rotate 36 * K * z } #declare K = K + 1; #end }
  #declare I = I + 1;
#end
object { O scale 2 pigment { rgb 1 } }
