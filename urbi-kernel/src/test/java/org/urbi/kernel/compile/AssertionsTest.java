package org.urbi.kernel.compile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.kernel.Evaluator;

/** What a failed assertion tells of the claim (manual, "Assertions"). */
class AssertionsTest {
  private final Evaluator code = new Evaluator();

  @AfterEach
  void close() {
    code.close();
  }

  private String failure(String source) {
    return code.error(source).getMessage();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1 == 2 | 1 != 2",
        "1 != 1 | 1 == 1",
        "2 < 1 | 2 >= 1",
        "2 <= 1 | 2 > 1",
        "1 > 2 | 1 <= 2",
        "1 >= 2 | 1 < 2",
        "1 === 2 | 1 !== 2",
        "1 ~= 2 | 1 !~= 2",
        "2 in [1, 3] | 2 not in [1, 3]",
        "1 not in [1, 3] | 1 in [1, 3]",
        "[1, 3].has(2) | [1, 3].has(2) == false",
        "[1, 3].hasNot(1) | [1, 3].hasNot(1) == false",
        "nil | nil == nil"
      })
  void aClaimIsToldWithTheValuesOfItsParts(String claim, String values) {
    String told = failure("assert(" + claim + ")");
    assertTrue(told.endsWith("failed assertion: " + claim + " (" + values + ")"), told);
  }

  @Test
  void namesAreToldWithTheirValues() {
    String slot = failure("var flag = false|; assert(flag)");
    assertTrue(slot.endsWith("failed assertion: flag (flag == false)"), slot);
    String local = failure("{ var ready = false; assert(ready) }");
    assertTrue(local.endsWith("failed assertion: ready (ready == false)"), local);
    String both = failure("{ var n = 3; assert(n < 2) }");
    assertTrue(both.endsWith("failed assertion: n < 2 (3 >= 2)"), both);
  }

  @Test
  void logicalClaimsAreToldByTheirResult() {
    String and = failure("assert(true && false)");
    assertTrue(and.contains("failed assertion: var '$t1' = true | if ('$t1')\n{ false }"), and);
    String or = failure("assert(false || nil)");
    assertTrue(or.contains("failed assertion: var '$t1' = false | if ('$t1')\n{ '$t1' }"), or);
  }

  @Test
  void partsAreEvaluatedOnce() {
    assertEquals(
        1.0, code.value("{ var n = 0; function next() { n += 1; n }; assert(next() == 1); n }"));
    String told = failure("{ var n = 0; function next() { n += 1; n }; assert(next() == 2) }");
    assertTrue(told.endsWith("(1 != 2)"), told);
  }

  @Test
  void eachClaimOfABlockIsChecked() {
    String told = failure("assert { 1 == 1; 2 == 3; 4 == 5 }");
    assertTrue(told.endsWith("failed assertion: 2 == 3 (2 != 3)"), told);
  }

  @Test
  void nothingIsEvaluatedWhereAssertionsAreOff() {
    assertEquals(
        0.0,
        code.value(
            "{ var n = 0; System.ndebug = true; assert(n++ == 7); System.ndebug = false; n }"));
  }

  @Test
  void anErrorOfAClaimIsNoFailedAssertion() {
    String told = failure("assert(nowhere == 1)");
    assertTrue(told.endsWith("lookup failed: nowhere"), told);
  }
}
