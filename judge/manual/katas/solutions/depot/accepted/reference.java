// List of numbers.
//
// A number for each shelf, and a word at a time.
import java.util.Scanner;

class Depot {
    public static void main(String[] words) {
        Scanner in = new Scanner(System.in);
        int[] boxes = new int[in.nextInt() + 1];
        in.next();
        for (String word = in.next(); !word.equals("end"); word = in.next()) {
            if (word.equals("how")) {
                for (int skip = 0; skip < 3; skip++) in.next();
                System.out.println(boxes[in.nextInt()]);
                continue;
            }
            int count = in.nextInt();
            in.next();
            in.next();
            int shelf = in.nextInt();
            if (word.equals("put")) boxes[shelf] += count;
            else if (boxes[shelf] < count) System.out.println("refused");
            else System.out.println(boxes[shelf] -= count);
        }
    }
}
