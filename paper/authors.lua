-- The authors of JOSS have names and affiliations; pandoc's own template wants names.
function Meta(meta)
  for index, author in ipairs(meta.author or meta.authors or {}) do
    meta.author = meta.author or {}
    meta.author[index] = author.name or author
  end
  return meta
end
