double middle(double a, double b) {
    return (long long)((a + b) / 2);
}
