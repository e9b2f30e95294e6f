/** What is said of texts that are not right: the catalogue of messages, and how it is filled in. */
@NullMarked
package org.urbi.lang.problem;

import org.jspecify.annotations.NullMarked;
