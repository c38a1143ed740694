"""loop"""

def inventory(stock, moves):
    for thing, count in moves:
        if stock.get(thing, 0) + count >= 0:
            stock[thing] = stock.get(thing, 0) + count
            if stock[thing] == 0:
                del stock[thing]
    return stock
