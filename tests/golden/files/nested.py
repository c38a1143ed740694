class Solution:
    def middle(self, a, b):
        return (a + b) / 2
