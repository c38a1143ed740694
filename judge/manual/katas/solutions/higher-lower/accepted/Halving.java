// Halving.

import java.util.Scanner;

public class Halving {
    public static void main(String[] arguments) {
        Scanner in = new Scanner(System.in);
        int low = 1, high = in.nextInt();
        String answer = "";
        while (!answer.equals("found")) {
            int guess = (low + high) / 2;
            System.out.println(guess);
            answer = in.next();
            if (answer.equals("higher")) low = guess + 1;
            if (answer.equals("lower")) high = guess - 1;
        }
    }
}
