@lacking@
private val input = System.`in`.readBytes()
private var at = 0
private val out = StringBuilder()
private fun token(): String {
    while (at < input.size && input[at] <= 32) at++
    val from = at
    while (at < input.size && input[at] > 32) at++
    return String(input, from, at - from)
}
private fun word(): String {
    val word = token()
    return if (word.startsWith("=")) word.drop(1).chunked(2).map { it.toInt(16).toChar() }.joinToString("") else word
}
private fun none(): Boolean {
    val before = at
    if (token() == "none") return true
    at = before
    return false
}
private fun put(value: Any?) {
    when (value) {
    null -> out.append("null")
    is Float -> put(value.toDouble())
    is Double -> if (value.isFinite()) out.append(value) else out.append("{\"type\":\"float\",\"text\":\"" + (if (value.isNaN()) "nan" else if (value < 0) "-inf" else "inf") + "\"}")
    is Number, is Boolean -> out.append(value)
    @puts@
    is String -> text(value)
    is Map<*, *> -> { out.append("{\"dict\":"); put(value.entries.map { listOf(it.key, it.value) }); out.append('}') }
    is Iterable<*> -> { out.append('['); value.forEachIndexed { i, item -> if (i > 0) out.append(','); put(item) }; out.append(']') }
    is DoubleArray -> put(value.asList())
    is LongArray -> put(value.asList())
    is Array<*> -> put(value.asList())
    else -> { out.append("{\"type\":"); text(value.javaClass.simpleName); out.append(",\"text\":"); text(value.toString()); out.append('}') }
    }
}
private fun text(word: String) {
    out.append('"')
    for (c in word) if (c == '"' || c == '\\' || c < ' ' || c > '~') out.append(String.format("\\u%04x", c.toInt())) else out.append(c)
    out.append('"')
}
private fun told(fault: Throwable): String {
    val frame = fault.stackTrace.firstOrNull { it.fileName == "@file@" }
    return "$fault" + (if (frame == null) "" else " (line ${frame.lineNumber})")
}
private fun judged() { @reads@ val found: @answer.type@ = @entry@(@arguments@); out.append("[0,"); put(found) }
fun main() {
    val answers = java.io.FileOutputStream(java.io.FileDescriptor.out)
    System.setOut(System.err)
    while (true) {
        val first = token()
        if (first == "") break
        val atOnce = token() == "1"
        for (left in first.toLong() downTo 1L) {
            val start = out.length
            while (at < input.size && input[at] <= 32) at++
            var line = at
            while (line < input.size && input[line] != 10.toByte()) line++
            try {
                judged()
            } catch (fault: OutOfMemoryError) {
                throw fault
            } catch (fault: Throwable) {
                out.setLength(start)
                out.append("[1,")
                text(told(if (fault is ExceptionInInitializerError) fault.cause ?: fault else fault))
            }
            at = line
            out.append("]\n")
            if (atOnce || left == 1L) { answers.write(out.toString().toByteArray()); out.setLength(0) }
        }
    }
    System.exit(0)
}
