package org.urbi.lang.grammar;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** The words that mean something to the scanner (manual, "Keywords"). */
class KeywordsTest {
  private static final List<String> WORDS =
      List.of(
          ("and and_eq assert at bitand bitor break call case catch class closure compl const"
                  + " continue default do else emit enum every external finally for foreach freezeif"
                  + " function get if import in loop loopn new not not_eq onleave or or_eq package"
                  + " return set stopif switch this throw timeout try var waituntil watch whenever"
                  + " while xor xor_eq")
              .split(" "));

  @Test
  void wordsAreThoseOfTheLexerAndTheirOtherSpellings() {
    assertEquals(WORDS, List.copyOf(new TreeSet<>(Keywords.all())));
  }

  @Test
  void differentSpellingsAreOneToken() {
    assertEquals(UrbiscriptLexer.FOR, Keywords.token("loopn"));
    assertEquals(UrbiscriptLexer.XOR_ASSIGN, Keywords.token("xor_eq"));
    assertEquals(UrbiscriptLexer.WORD, Keywords.token("While"));
  }

  @Test
  void wordsOfOnePlaceMayNameAnythingElsewhere() {
    for (String word : List.of("get", "import", "new", "package", "set")) {
      assertFalse(Keywords.keyword(word), word);
    }
    for (String word : List.of("while", "xor_eq", "goto", "static")) {
      assertTrue(Keywords.keyword(word), word);
    }
  }
}
