for _ in range(int(input())):
    print(sum(map(float, input().split())) / 2)
