import java.util.List;
@lacking@
final class JudgeDriver {
    private static byte[] in;
    private static int at;
    private static final StringBuilder out = new StringBuilder();
    private static String token() {
        while (at < in.length && in[at] <= ' ') at++;
        int from = at;
        while (at < in.length && in[at] > ' ') at++;
        return new String(in, 0, from, at - from);
    }
    private static String word() {
        String word = token();
        return word.startsWith("=") ? new String(java.util.HexFormat.of().parseHex(word.substring(1)), java.nio.charset.StandardCharsets.ISO_8859_1) : word;
    }
    private static double real() { return Double.parseDouble(token()); }
    private static long integer() { return Long.parseLong(token()); }
    private static boolean none() { int before = at; if (token().equals("none")) return true; at = before; return false; }
    private static <T> List<T> list(java.util.function.Supplier<T> read) {
        var found = new java.util.ArrayList<T>();
        for (long left = integer(); left > 0; left--) found.add(read.get());
        return found;
    }
    private static double[] reals() { var found = new double[(int) integer()]; for (int i = 0; i < found.length; i++) found[i] = real(); return found; }
    private static long[] integers() { var found = new long[(int) integer()]; for (int i = 0; i < found.length; i++) found[i] = integer(); return found; }
    private static void put(Object value) {
        if (value == null) out.append("null");
        else if (value instanceof Float single) put((double) single);
        else if (value instanceof Double d && !Double.isFinite(d)) out.append("{\"type\":\"float\",\"text\":\"").append(Double.isNaN(d) ? "nan" : d < 0 ? "-inf" : "inf").append("\"}");
        else if (value instanceof Number || value instanceof Boolean) out.append(value);
        else if (value instanceof Iterable<?> items) { out.append('['); String gap = ""; for (Object item : items) { out.append(gap); put(item); gap = ","; } out.append(']'); }
        else if (value.getClass().isArray()) { out.append('['); for (int i = 0; i < java.lang.reflect.Array.getLength(value); i++) { if (i > 0) out.append(','); put(java.lang.reflect.Array.get(value, i)); } out.append(']'); }
        else if (value instanceof java.util.Optional<?> held) put(held.orElse(null));
        @puts@
        else if (value instanceof String word) text(word);
        else { out.append("{\"type\":"); text(value.getClass().getSimpleName()); out.append(",\"text\":"); text(String.valueOf(value)); out.append('}'); }
    }
    private static void text(String word) {
        out.append('"');
        for (char c : word.toCharArray()) if (c == '"' || c == '\\' || c < 32 || c > 126) out.append(String.format("\\u%04x", (int) c)); else out.append(c);
        out.append('"');
    }
    private static String told(Throwable fault) {
        for (var frame : fault.getStackTrace()) if ("@file@".equals(frame.getFileName())) return fault + " (line " + frame.getLineNumber() + ")";
        return fault.toString();
    }
    private static long call;  // which one of calls in a row is made
    // @if methods
    private static @made@ made() throws Throwable { @reads@ return new @made@(@arguments@); }
    private static void answer() throws Throwable {
        @made@ judged = made();
        long calls = integer();
        out.append("[0,[");
        for (call = 1; call <= calls; call++) {
            if (call > 1) out.append(',');
            String name = word();
            @calls@
        }
        out.append(']');
    }
    // @end
    // @if not methods
    private static void answer() throws Throwable { @reads@ Object found = @holder@.@entry@(@arguments@); out.append("[0,"); put(found); }
    // @end
    public static void main(String[] words) throws java.io.IOException {
        var answers = new java.io.FileOutputStream(java.io.FileDescriptor.out);
        System.setOut(System.err);
        in = System.in.readAllBytes();
        for (String first = token(); !first.isEmpty(); first = token()) {
            boolean atOnce = integer() == 1;
            for (long cases = Long.parseLong(first); cases > 0; cases--) {
                int start = out.length();
                call = 0;
                while (at < in.length && in[at] <= ' ') at++;
                int line = at;
                while (line < in.length && in[line] != '\n') line++;
                try { answer(); }
                catch (OutOfMemoryError fault) { throw fault; }
                catch (Throwable fault) { out.setLength(start); out.append("[1,"); text(told(fault instanceof ExceptionInInitializerError && fault.getCause() != null ? fault.getCause() : fault) + (call > 0 ? ", in call " + call : "")); }
                at = line;
                out.append("]\n");
                if (atOnce || cases == 1) { answers.write(out.toString().getBytes()); out.setLength(0); }
            }
        }
        System.exit(0);
    }
}
