//! about: x^n + y^n + z^n = 1, order X, along 500 rays to the middle
//! extremity: X
//! steps: 2 to 34 by 2
//! truth: what it finds
//! tolerance: 1e-6
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
#declare P3 = poly { X, <
  #local First = 1;
  #local A = X;
  #while (A >= 0)
    #local B = X - A;
    #while (B >= 0)
      #local C = X - A - B;
      #while (C >= 0)
        #if (First = 0) , #end
        #local First = 0;
        #if (A = X | B = X | C = X) 1 #else #if (A + B + C = 0) -1 #else 0 #end #end
        #local C = C - 1;
      #end
      #local B = B - 1;
    #end
    #local A = A - 1;
  #end
  > sturm }
#declare S = seed(11);
#declare I = 0;
#declare Worst = 0;
#while (I < 500)
  #local D = vnormalize(<rand(S), rand(S), rand(S)> - .5);
  #local T = pow(pow(abs(D.x), X) + pow(abs(D.y), X) + pow(abs(D.z), X), -1 / X);
  #local N = <0, 0, 0>;
  #local P = trace(P3, D * 4, -D, N);
  #declare Worst = max(Worst, (vlength(N) = 0 ? 1 : abs(vlength(P) / T - 1)));
  #declare I = I + 1;
#end
#debug concat("found ", str(Worst, 0, 20), "\n")
