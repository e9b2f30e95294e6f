package org.urbi.tests;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A frame of compiled code has no room for variables until one is needed: here that is one of code
 * that is not compiled.
 */
class LateVariablesTest {
  private static final String PROGRAM =
      """
      function branches() { var done = 0; for& (var i : 3) { done += i }; done }|;
      for| (40) branches();
      function branchesOfList() { var done = []; for& (var s : ["a", "b"]) { done << s }; done.sort }|;
      for| (40) branchesOfList();
      function keys() {
        var sum = 0; for (var k : ["a" => 1, "b" => 2]) { sum += k.first.size }; sum
      }|;
      for| (40) keys();
      function lazily { call.evalArgAt(0) }|;
      function argument() { lazily({ var x = 3; x += 1; x }) }|;
      for| (40) argument();
      function parallel() { { var a = 1; a } & { var b = 2; b }; 3 }|;
      for| (40) parallel();
      function caught() { try { throw 1 } catch (var e) { e } }|;
      for| (40) caught();
      function scoped() { var t = Tag.new; t: { var z = 6; z } }|;
      for| (40) scoped();
      function watched() {
        var seen = 0; var e = Event.new; at (e?(var v)) seen += v; e!(4); sleep(1ms); seen
      }|;
      for| (40) watched();
      function inner() { function f { var q = 1; for& (var i : 2) q += i; q }; f }|;
      for| (40) inner();
      [branches, branchesOfList, keys, argument, parallel, caught, scoped, watched, inner];
      """;

  @ParameterizedTest
  @CsvSource({"1, 0", "2, 0", "7, 0", "1, 3", "3, 2"})
  void theyDoWhatTheInterpreterDoes(int threshold, int doubt) {
    CompiledCodeTest.compare(threshold, doubt, PROGRAM);
  }
}
