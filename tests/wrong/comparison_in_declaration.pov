// A comparison needs brackets in a declaration.
#declare A = 3;
#declare Large = A > 2;
