package org.urbi.kernel.tier;

import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.lang.classfile.ClassFile;
import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Sequences;
import org.urbi.lang.source.Source;
import org.urbi.lang.source.Span;

/** Copies of a loop that are not alike are noticed, wherever they differ. */
class CrossingsTest {
  private static final Span NOWHERE =
      new Span(new Source("", 1, new Source.Line(0, null, 1)), 0, 0);

  private final Node first = new Sequences.Noop(NOWHERE);
  private final Node second = new Sequences.Noop(NOWHERE);
  private final Crossings crossings = new Crossings();

  /** Two places of a slow copy, in some method. */
  private void with(Consumer<Label[]> labels) {
    ClassFile.of()
        .build(
            ClassDesc.of("Some"),
            type ->
                type.withMethodBody(
                    "run",
                    ConstantDescs.MTD_void,
                    ClassFile.ACC_STATIC,
                    code -> labels.accept(emit(code))));
  }

  private Label[] emit(CodeBuilder code) {
    Label[] labels = {code.newBoundLabel(), code.newBoundLabel()};
    code.return_();
    crossings.add(first, 7, labels[0]);
    crossings.add(second, 9, labels[1]);
    return labels;
  }

  @Test
  void theSamePlacesAreFoundInTheirOrder() {
    with(labels -> {
      assertSame(labels[0], crossings.next(first, 7));
      assertSame(labels[1], crossings.next(second, 9));
      crossings.end();
    });
  }

  @Test
  void anotherStatementIsNoticed() {
    with(labels -> assertThrows(IllegalArgumentException.class, () -> crossings.next(second, 7)));
  }

  @Test
  void valuesInOtherSlotsAreNoticed() {
    with(labels -> assertThrows(IllegalArgumentException.class, () -> crossings.next(first, 8)));
  }

  @Test
  void moreOrLessIsNoticed() {
    with(labels -> {
      crossings.next(first, 7);
      assertThrows(IllegalArgumentException.class, crossings::end);
      crossings.next(second, 9);
      assertThrows(IllegalArgumentException.class, () -> crossings.next(second, 9));
    });
  }
}
