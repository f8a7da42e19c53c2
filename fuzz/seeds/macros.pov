#version 3.7;
#macro Sum(A, B) (A + B) #end
#macro Deep(N) #if (N > 0) Deep(N - 1) #else 7 #end #end
#macro Change(P) #declare P = P * 2; #end
#macro Half() sphere { 0, #end
#macro Back(A) #local L = <A, 1, 2>; vnormalize(L) #end
#declare Q = 3;
Change(Q)
Half() Sum(1, Q) }
#declare V = 2 * Back(Q) + x;
#declare W = (Deep(5));
#debug concat(str(W, 0, 2), vstr(3, V, ",", 0, 3), "\n")
