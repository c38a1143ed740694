"""Problems of ours as packages that other judges read: Kattis and ICPC."""
