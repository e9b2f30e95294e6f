/** The catalogue of the parser's messages, and the templates of their texts. */
@NullMarked
package org.urbi.lang.problem;

import org.jspecify.annotations.NullMarked;
