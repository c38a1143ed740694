package main

import (
	judgeHex "encoding/hex"; judgeJSON "encoding/json"; judgeFmt "fmt"; judgeIO "io"; judgeMath "math"; judgeOS "os"
	judgeRuntime "runtime"; judgeDebug "runtime/debug"; judgeConv "strconv"; judgeStrings "strings"; @bigs@
)

@lacking@
@main@

var judgeIn string
var judgeOut []byte

func judgeToken() string {
	i := 0
	for i < len(judgeIn) && judgeIn[i] <= ' ' { i++ }
	j := i
	for j < len(judgeIn) && judgeIn[j] > ' ' { j++ }
	word := judgeIn[i:j]
	judgeIn = judgeIn[j:]
	return word
}
func judgeText() string {
	word := judgeToken()
	if word == "" || word[0] != '=' { return word }
	text, _ := judgeHex.DecodeString(word[1:])
	return string(text)
}
func judgeReal() float64 { v, _ := judgeConv.ParseFloat(judgeToken(), 64); return v }
func judgeInt() int { v, _ := judgeConv.Atoi(judgeToken()); return v }
// @if big

func judgeBig() *judgeBigs.Int {
	word := judgeToken()
	if len(word) <= 18 { n, _ := judgeConv.ParseInt(word, 10, 64); return judgeBigs.NewInt(n) }
	n, _ := new(judgeBigs.Int).SetString(word, 10)
	return n
}
func judgePutWhole[T int | int64 | int32 | *judgeBigs.Int](v T) { // where it is a count, an int is what is returned
	switch n := any(v).(type) {
	case *judgeBigs.Int:
		if n == nil { judgeOut = append(judgeOut, "null"...) } else { judgeOut = n.Append(judgeOut, 10) }
	case int: judgePutInt(n)
	case int64: judgePutInt(n)
	case int32: judgePutInt(n)
	}
}
// @end

func judgeList[T any](read func() T) []T {
	found := make([]T, judgeInt())
	for i := range found { found[i] = read() }
	return found
}
// @if dicts
func judgeMap[K comparable, V any](key func() K, value func() V) map[K]V {
	found := map[K]V{}
	for left := judgeInt(); left > 0; left-- { first := key(); found[first] = value() }
	return found
}
// @end
func judgeOptional[T any](read func() T) *T {
	before := judgeIn
	if judgeToken() == "none" { return nil }
	judgeIn = before
	v := read()
	return &v
}
func judgeComma() { judgeOut = append(judgeOut, ',') }
func judgeClose() {
	if judgeOut[len(judgeOut)-1] == ',' { judgeOut = judgeOut[:len(judgeOut)-1] }
	judgeOut = append(judgeOut, ']')
}
func judgePutWord(v string) { text, _ := judgeJSON.Marshal(v); judgeOut = append(judgeOut, text...) }
func judgePutBool(v bool) { judgeOut = judgeConv.AppendBool(judgeOut, v) }
func judgePutInt[T int | int64 | int32](v T) { judgeOut = judgeConv.AppendInt(judgeOut, int64(v), 10) }
func judgePutReal(v float64) {
	if judgeMath.IsNaN(v) || judgeMath.IsInf(v, 0) {
		judgeOut = append(judgeOut, judgeFmt.Sprintf("{\"type\":\"float\",\"text\":\"%v\"}", v)...)
	} else {
		judgeOut = judgeConv.AppendFloat(judgeOut, v, 'g', -1, 64)
	}
}
func judgeTold(fault any) string {
	text := judgeFmt.Sprint(fault)
	if _, known := fault.(judgeRuntime.Error); !known { text = "panic: " + text }
	places := make([]uintptr, 64)
	frames := judgeRuntime.CallersFrames(places[:judgeRuntime.Callers(0, places)])
	for {
		frame, more := frames.Next()
		if judgeStrings.HasSuffix(frame.File, "@file@") { return judgeFmt.Sprintf("%s (line %d)", text, frame.Line) }
		if !more { return text }
	}
}
func judgeAnswer(start int) {
	defer func() {
		if fault := recover(); fault != nil {
			judgeOut = append(judgeOut[:start], "[1,"...)
			judgePutWord(judgeTold(fault))
		}
	}()
	@reads@
	@answer.found@ := @entry@(@arguments@)
	judgeOut = append(judgeOut, "[0,"...)
	@put@
}
func init() {
	answers := new(judgeOS.File)
	*answers = *judgeOS.Stdout
	*judgeOS.Stdout = *judgeOS.Stderr // for whoever holds it already, too
	judgeDebug.SetMaxStack(64 << 20)
	var all judgeStrings.Builder
	if input, fault := judgeOS.Stdin.Stat(); fault == nil { all.Grow(int(input.Size())) }
	judgeIO.Copy(&all, judgeOS.Stdin)
	judgeIn = all.String()
	for {
		cases, fault := judgeConv.Atoi(judgeToken())
		if fault != nil { break }
		atOnce := judgeInt()
		for ; cases > 0; cases-- {
			line, rest := judgeLine()
			judgeIn = line
			judgeAnswer(len(judgeOut))
			judgeIn = rest
			judgeOut = append(judgeOut, "]\n"...)
			if atOnce == 1 || cases == 1 {
				if _, fault := answers.Write(judgeOut); fault != nil { judgeOS.Exit(1) }
				judgeOut = judgeOut[:0]
			}
		}
	}
	judgeOS.Exit(0)
}
func judgeLine() (string, string) {
	for len(judgeIn) > 0 && judgeIn[0] <= ' ' { judgeIn = judgeIn[1:] }
	if end := judgeStrings.IndexByte(judgeIn, '\n'); end >= 0 { return judgeIn[:end], judgeIn[end+1:] }
	return judgeIn, ""
}
